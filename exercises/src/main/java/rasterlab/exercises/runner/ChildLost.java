package rasterlab.exercises.runner;

import rasterlab.exercises.score.Message;

/** A child gave no answer that can be used, and is dead now. */
final class ChildLost extends Exception {
    private static final long serialVersionUID = 1L;

    /** Why there is no answer. */
    enum Reason {
        /** The wall limit passed. */
        TIME,
        /** It ended because its memory did not suffice. */
        MEMORY,
        /** It ended because it printed or plotted too much. */
        OUTPUT,
        /** It was ended from here, or could not be had. */
        KILLED,
        /** A signal ended it, or it ended with a status that looks like that. */
        SIGNAL,
        /** It ended for another reason. */
        ENDED,
        /** It answered something that the protocol does not know. */
        PROTOCOL
    }

    private final Reason reason;
    private final transient Message said;

    ChildLost(Reason reason, Message said) {
        super(said.toString());
        this.reason = reason;
        this.said = said;
    }

    Message said() {
        return said;
    }

    Reason reason() {
        return reason;
    }

    /**
     * Whether the student's method may have had no part in it.
     *
     * @param again whether it happened in a second try, too
     */
    boolean isOursToRepeat(boolean again) {
        return reason == Reason.KILLED || (reason == Reason.SIGNAL && !again);
    }
}
