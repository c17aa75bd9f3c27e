// The process of the hodt command: its streams and signals.
// Tested by tests/app/faults_test.cpp.
#include <csignal>
#include <thread>

#include "app/command.h"
#include <fcntl.h>
#include <unistd.h>

#include "hodt/io/atomic_write.h"

namespace hodt::app {

namespace {

/// A closed standard stream would lend its number to the next file that opens, and what is printed
/// would end up there.
void occupy_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // Opened the wrong way round, so that using it fails as it did before.
    if (::fcntl(stream, F_GETFD) < 0) {
      ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
  }
}

/// Failing writes are to be errors that we see, not signals that kill.
void ignore_write_signals() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

/// The signals that end a program and that nobody has set aside: nohup ignores SIGHUP, say.
sigset_t ending_signals() {
  sigset_t ending, blocked;
  sigemptyset(&ending);
  pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU}) {
    struct sigaction action = {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler == SIG_DFL && !sigismember(&blocked, signal)) sigaddset(&ending, signal);
  }
  return ending;
}

/// Ends the process as the signal would have, after its temporary files.
void wait_for_the_end(const sigset_t& ending) {
  int signal = 0;
  sigwait(&ending, &signal);
  abandon_output_files();
  pthread_sigmask(SIG_UNBLOCK, &ending, nullptr);
  raise(signal);
}

/// A signal is not to leave temporary files. A thread waits for it, as a handler could do little.
/// It starts before all others, so that they inherit that the signals go to it alone.
void clean_up_on_signals() {
  const sigset_t ending = ending_signals();
  pthread_sigmask(SIG_BLOCK, &ending, nullptr);
  std::thread([ending] { wait_for_the_end(ending); }).detach();
}

}  // namespace

}  // namespace hodt::app

int main(int argc, char** argv) {
  hodt::app::occupy_standard_streams();
  hodt::app::ignore_write_signals();
  hodt::app::clean_up_on_signals();
  return hodt::app::run(argc, argv);
}
