package rasterlab.app.cli.run;

import rasterlab.app.outcome.Complaint;

/** What is said where {@code --steps} is asked of a method without any. */
final class Steps {
    private Steps() {}

    static Complaint none(String method) {
        return Complaint.badInput("--steps: method '" + method + "' has no steps");
    }
}
