// Runs tasks in processes of their own, a few at a time.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace explore::app
{
/** The texts that `work(i)` returns for each of the tasks, which `names` stand for, each computed in a child process,
 * at most `jobs` at a time. A task's error is thrown again here, by its type; of several, that of the first task. A
 * child that crashes is a std::runtime_error that says so. `done(i)` is called here as each task ends. Must be called
 * without other threads. */
std::vector<std::string> inProcesses(const std::vector<std::string>& names, int jobs,
                                     const std::function<std::string(std::size_t)>& work,
                                     const std::function<void(std::size_t)>& done);
}  // namespace explore::app
