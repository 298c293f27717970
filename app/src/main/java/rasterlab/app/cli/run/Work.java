package rasterlab.app.cli.run;

import rasterlab.app.outcome.Complaint;

/** Refuses at once what could not end within seconds. */
final class Work {
    private Work() {}

    /**
     * Passes where there is little enough to do.
     *
     * @param place in the input, or the option, that makes it too much
     * @param what is counted, in the plural
     * @throws Complaint if it is too much
     */
    static void requireAtMost(String place, long most, String what, long count) {
        if (count > most)
            throw Complaint.badInput(place + ": at most " + most + " " + what + ", got " + count);
    }
}
