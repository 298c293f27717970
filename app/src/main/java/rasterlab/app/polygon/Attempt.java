package rasterlab.app.polygon;

import rasterlab.engine.study.LimitReached;

/** Runs a method and takes down how it ended. */
final class Attempt {
    private Outcome.Ending ending = Outcome.Ending.ENDED;
    private String message = "";

    Attempt(Runnable method) {
        try {
            method.run();
        } catch (LimitReached endless) {
            ending = Outcome.Ending.ENDLESS;
        } catch (IllegalArgumentException refused) {
            ending = Outcome.Ending.REFUSED;
            message = String.valueOf(refused.getMessage());
        } catch (RuntimeException | StackOverflowError crashed) {
            ending = Outcome.Ending.CRASHED;
            message = crashed.toString();
        }
    }

    Outcome.Ending ending() {
        return ending;
    }

    String message() {
        return message;
    }
}
