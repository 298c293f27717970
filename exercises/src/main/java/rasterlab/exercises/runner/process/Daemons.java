package rasterlab.exercises.runner.process;

import java.util.concurrent.ThreadFactory;

/** Threads that do not keep the program alive. */
public final class Daemons {
    private Daemons() {}

    public static ThreadFactory named(String name) {
        return task -> {
            Thread thread = new Thread(task, name);
            thread.setDaemon(true);
            return thread;
        };
    }
}
