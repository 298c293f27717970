package rasterlab.engine.study;

import rasterlab.engine.range.Bounds;

/**
 * How far a study has come.
 *
 * @param done finished pieces of work, 0 to {@code total}
 * @param method the method just finished with
 * @param workload the workload it ran on
 */
public record Progress(int done, int total, String method, String workload) {
    public Progress {
        Bounds.require("done", done, 0, total);
    }
}
