package rasterlab.app.course;

import java.time.Instant;
import java.util.Optional;

/**
 * How far a student has come with an exercise.
 *
 * @param points the most that were earned; empty as long as nothing is graded
 * @param deadline of handing in; empty where there is none
 */
record Standing(StandingState state, Optional<Earned> points, Optional<Instant> deadline) {
    static final Standing NOT_TRIED =
            new Standing(StandingState.NOT_TRIED, Optional.empty(), Optional.empty());

    enum StandingState {
        NOT_TRIED,
        /** The work was handed in, without a result as yet. */
        WAITING,
        GRADED
    }

    /**
     * @param of the most that can be earned
     */
    record Earned(int points, int of) {
        /** Whether this is the larger share; of equal ones neither is. */
        boolean exceeds(Earned other) {
            return (long) points * other.of > (long) other.points * of;
        }
    }

    static Standing graded(Earned earned) {
        return new Standing(StandingState.GRADED, Optional.of(earned), Optional.empty());
    }
}
