#pragma once
// Between the library's exception and the inner one. No other header is inner.
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "app/library/error.h"
#include "atlas/base/error.h"

namespace burl::library {

/// The sentence with options of the command line by their names alone: "size" for "--size".
std::string without_dashes(std::string sentence);

/// Returns what `work` returns; an exception of it becomes the library's Error, but for
/// std::bad_alloc.
template <class Work>
auto guarded(Work&& work) {
    try {
        return std::forward<Work>(work)();
    } catch (const burl::Error& error) {
        throw Error(ErrorKind(int(error.code())), without_dashes(error.what()));
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw Error(ErrorKind::runtime, error.what());
    }
}

}  // namespace burl::library
