/* A thread that Mono did not make, as those of Unity's jobs are, whose x87 unit rounds to 64 bits. */
#include <pthread.h>
#include <stddef.h>

static const unsigned short extended_precision = 0x37F;

typedef void (*callback)(void);

/* What the calling thread's x87 unit does. */
unsigned short control_word(void)
{
    unsigned short word;
    __asm__ volatile("fnstcw %0" : "=m"(word));
    return word;
}

static void call_in_extended_precision(callback call)
{
    __asm__ volatile("fldcw %0" : : "m"(extended_precision));
    call();
}

/* Mono meets the thread in the first call, and changes its control word; the second call changes it back. */
static void *run(void *argument)
{
    callback *calls = argument;
    call_in_extended_precision(calls[0]);
    call_in_extended_precision(calls[1]);
    return NULL;
}

/* Calls back twice on a new thread and waits for it; 0 if there was a thread. */
int run_on_native_thread(callback first, callback second)
{
    callback calls[] = { first, second };
    pthread_t thread;
    int problem = pthread_create(&thread, NULL, run, calls);
    if (problem == 0) pthread_join(thread, NULL);
    return problem;
}
