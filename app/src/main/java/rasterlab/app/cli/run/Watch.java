package rasterlab.app.cli.run;

import java.time.Duration;
import java.util.concurrent.CancellationException;
import java.util.function.Supplier;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.format.AnswerLimitReached;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.study.Guard;

/** Says on the command line that a method refused, crashed or did not end under guard. */
final class Watch {
    private final Duration limit;

    /**
     * @param limit the longest wait, wall time
     */
    Watch(Duration limit) {
        this.limit = limit;
    }

    /**
     * @param name of the method, for the message
     * @throws Complaint if the work refuses ({@link IllegalArgumentException}), crashes, or does
     *     not end in time
     */
    <T> T call(String name, Supplier<T> work) {
        var outcome = outcome(name, work);
        if (outcome instanceof Guard.Returned<T> returned) return returned.value();
        if (outcome instanceof Guard.Failed<T> threw) throw explained(name, threw.cause());
        throw Complaint.gaveUp(
                name + " did not end within " + limit.toSeconds() + " s and was given up");
    }

    private <T> Guard.CallOutcome<T> outcome(String name, Supplier<T> work) {
        try {
            return Guard.call("method " + name, work::get, limit);
        } catch (CancellationException interrupted) {
            throw Complaint.gaveUp(name + " was interrupted");
        }
    }

    private static Complaint explained(String name, Throwable cause) {
        if (cause instanceof Complaint complaint) return complaint;
        if (cause instanceof InvalidInput invalid) return Complaint.badInput(invalid.getMessage());
        if (cause instanceof AnswerLimitReached tooMuch)
            return Complaint.gaveUp(tooMuch.getMessage());
        if (cause instanceof IllegalArgumentException refusal)
            return Complaint.refused(name + " refuses: " + refusal.getMessage());
        return Complaint.gaveUp(name + " crashed: " + cause);
    }
}
