package rasterlab.app.light.step;

import java.util.Optional;
import java.util.function.Supplier;
import rasterlab.app.canvas.player.Steps;

/**
 * Plays a program's answers where there are some, else what the lab plays without it.
 *
 * @param shown the answers that the lab shows now
 * @param walk how many of them are shown
 */
public record OwnTimeline(Supplier<Optional<OwnSteps>> shown, OwnWalk walk, Steps otherwise)
        implements Steps {
    /** Goes through the answers of one program. */
    private record Answers(int last, OwnWalk walk) implements Steps {
        @Override
        public int step() {
            return walk.step(last);
        }

        @Override
        public void goTo(int step) {
            walk.goTo(step, last);
        }
    }

    private Steps now() {
        return shown.get().<Steps>map(one -> new Answers(one.count(), walk)).orElse(otherwise);
    }

    @Override
    public int first() {
        return now().first();
    }

    @Override
    public int last() {
        return now().last();
    }

    @Override
    public int step() {
        return now().step();
    }

    @Override
    public void goTo(int step) {
        now().goTo(step);
    }

    @Override
    public void rest() {
        now().rest();
    }

    @Override
    public boolean turnsRound() {
        return now().turnsRound();
    }
}
