#include "sandbox/filter.h"
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <linux/filter.h>
#include <memory>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <system_error>
#include <unistd.h>

namespace sandbox {
namespace {

    using Context = std::unique_ptr<void, void (*)(scmp_filter_ctx)>;

    // A rule for a call that this architecture does not have says nothing: its result is left.
    template <typename... Conditions> void refuse(const Context& context, int error, int call, Conditions... conditions)
    {
        (void)seccomp_rule_add(
            context.get(), SCMP_ACT_ERRNO(static_cast<uint32_t>(error)), call, sizeof...(conditions), conditions...);
    }

    void refuseProcesses(const Context& context)
    {
        refuse(context, EAGAIN, SCMP_SYS(fork));
        refuse(context, EAGAIN, SCMP_SYS(vfork));
        refuse(context, EAGAIN, SCMP_SYS(clone), SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, 0));
        // Its flags are in memory, where a filter cannot look. The C library takes clone instead.
        refuse(context, ENOSYS, SCMP_SYS(clone3));
    }

    void refuseOthers(const Context& context)
    {
        for (const int call :
            { SCMP_SYS(setsid), SCMP_SYS(setpgid), SCMP_SYS(socket), SCMP_SYS(ptrace), SCMP_SYS(process_vm_readv),
                SCMP_SYS(process_vm_writev), SCMP_SYS(kill), SCMP_SYS(tkill), SCMP_SYS(rt_sigqueueinfo),
                SCMP_SYS(rt_tgsigqueueinfo), SCMP_SYS(pidfd_open), SCMP_SYS(pidfd_send_signal), SCMP_SYS(unshare),
                SCMP_SYS(setns), SCMP_SYS(mount), SCMP_SYS(bpf), SCMP_SYS(perf_event_open), SCMP_SYS(userfaultfd),
                SCMP_SYS(io_uring_setup), SCMP_SYS(shmget), SCMP_SYS(msgget), SCMP_SYS(semget), SCMP_SYS(mq_open),
                SCMP_SYS(add_key), SCMP_SYS(keyctl), SCMP_SYS(memfd_create), SCMP_SYS(socketpair) })
            refuse(context, EPERM, call);
        refuse(context, EPERM, SCMP_SYS(tgkill), SCMP_A2(SCMP_CMP_NE, SIGABRT)); // abort() signals itself
        refuse(context, EPERM, SCMP_SYS(prlimit64), SCMP_A0(SCMP_CMP_NE, 0)); // limits of another process
        for (const unsigned command : { F_SETOWN, F_SETOWN_EX, F_SETSIG }) // signals by way of a socket
            refuse(context, EPERM, SCMP_SYS(fcntl), SCMP_A1(SCMP_CMP_EQ, command));
    }

    std::vector<sock_filter> makeFilter()
    {
        const Context context(seccomp_init(SCMP_ACT_ALLOW), seccomp_release);
        if (!context)
            throw std::system_error(ENOSYS, std::generic_category(), "a filter of system calls");
        refuseProcesses(context);
        refuseOthers(context);
        const int file = memfd_create("filter", MFD_CLOEXEC);
        const int exported = seccomp_export_bpf(context.get(), file);
        const off_t size = lseek(file, 0, SEEK_END);
        std::vector<sock_filter> filter(static_cast<std::size_t>(size > 0 ? size : 0) / sizeof(sock_filter));
        const ssize_t got = pread(file, filter.data(), filter.size() * sizeof(sock_filter), 0);
        close(file);
        if (exported != 0 || got != size)
            throw std::system_error(-exported, std::generic_category(), "the filter of system calls");
        return filter;
    }

}

const std::vector<sock_filter>& systemCallFilter()
{
    static const std::vector<sock_filter> filter = makeFilter();
    return filter;
}

}
