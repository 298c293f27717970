package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.nio.file.Path;

/** Something failed beside servers that said something in their logs. */
final class LoggedFailure extends IOException {
    private static final long serialVersionUID = 1;

    private final String logs;

    /**
     * @param logs the folder with their copies
     */
    LoggedFailure(Exception failed, Path logs) {
        super(failed.getMessage(), failed);
        this.logs = logs.toString();
    }

    String logs() {
        return logs;
    }
}
