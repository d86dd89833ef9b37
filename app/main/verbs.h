#pragma once
// The verbs of the program `burl`, one file each (verb_*.cpp). Each adds its options to the command
// line and a callback that does the work; errors are thrown as burl::Error and printed by main.
namespace CLI {
class App;
}

namespace burl {

void add_bake(CLI::App& program);
void add_render(CLI::App& program);
void add_batch(CLI::App& program);
void add_diff(CLI::App& program);
void add_metrics(CLI::App& program);
void add_bench(CLI::App& program);
void add_eval(CLI::App& program);
void add_figures(CLI::App& program);
void add_page(CLI::App& program);
void add_list(CLI::App& program);
void add_show(CLI::App& program);
void add_manual(CLI::App& program);

}  // namespace burl
