package rasterlab.app.canvas.player;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class TurnStepsTest {
    private double turns;
    private final TurnSteps steps =
            new TurnSteps(8) {
                @Override
                protected double turns() {
                    return turns;
                }

                @Override
                protected void turnTo(double next) {
                    turns = next;
                }
            };

    @Test
    void eachStepIsReadAsItWasGoneTo() {
        for (int step = steps.first(); step <= steps.last(); step++) {
            steps.goTo(step);
            assertEquals(step / 8.0, turns);
            assertEquals(step, steps.step());
        }
    }

    @Test
    void turnsBeyondAWholeOneAreFoldedIntoIt() {
        turns = -0.125;
        assertEquals(7, steps.step());
        turns = 3.25;
        assertEquals(2, steps.step());
    }

    @Test
    void aHalfStepBelowAWholeTurnIsTheFirstStep() {
        turns = 15.5 / 16;
        assertEquals(0, steps.step());
    }

    @Test
    void goesToTheNearerEnd() {
        steps.goTo(-1);
        assertEquals(0, turns);
        steps.goTo(8);
        assertEquals(7 / 8.0, turns);
    }
}
