package rasterlab.app.polygon.outcome;

import rasterlab.engine.study.LimitReached;

/** Runs a method and takes down how it ended. */
final class Attempt {
    private MethodOutcome.Ending ending = MethodOutcome.Ending.ENDED;
    private String message = "";

    Attempt(Runnable method) {
        try {
            method.run();
        } catch (LimitReached endless) {
            ending = MethodOutcome.Ending.ENDLESS;
        } catch (IllegalArgumentException refused) {
            ending = MethodOutcome.Ending.REFUSED;
            message = String.valueOf(refused.getMessage());
        } catch (RuntimeException | StackOverflowError crashed) {
            ending = MethodOutcome.Ending.CRASHED;
            message = crashed.toString();
        }
    }

    MethodOutcome.Ending ending() {
        return ending;
    }

    String message() {
        return message;
    }
}
