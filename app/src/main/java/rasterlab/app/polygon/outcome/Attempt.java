package rasterlab.app.polygon.outcome;

import rasterlab.engine.study.LimitReached;

/** Runs a method and takes down how it ended. */
final class Attempt {
    private MethodOutcome.MethodEnding ending = MethodOutcome.MethodEnding.ENDED;
    private String message = "";

    Attempt(Runnable method) {
        try {
            method.run();
        } catch (LimitReached endless) {
            ending = MethodOutcome.MethodEnding.ENDLESS;
        } catch (IllegalArgumentException refused) {
            ending = MethodOutcome.MethodEnding.REFUSED;
            message = String.valueOf(refused.getMessage());
        } catch (RuntimeException | StackOverflowError crashed) {
            ending = MethodOutcome.MethodEnding.CRASHED;
            message = crashed.toString();
        }
    }

    MethodOutcome.MethodEnding ending() {
        return ending;
    }

    String message() {
        return message;
    }
}
