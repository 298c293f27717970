package rasterlab.exercises.runner.process;

import java.time.Duration;
import rasterlab.exercises.score.Message;

/** A child gave no answer that can be used, and is dead now. */
public final class ChildLost extends Exception {
    private static final long serialVersionUID = 1L;

    /** Why there is no answer. */
    public enum LossReason {
        /** The limit of processor time, or that of wall time, passed. */
        TIME,
        /** The child ended because its memory did not suffice. */
        MEMORY,
        /** The child ended because it printed or plotted too much. */
        OUTPUT,
        /** The child was ended from here, or could not be had. */
        KILLED,
        /** A signal ended it, or it ended with a status that looks like that. */
        SIGNAL,
        /** The child ended for another reason. */
        ENDED,
        /** The child answered something that the protocol does not know. */
        PROTOCOL
    }

    private final LossReason reason;
    private final transient Message said;
    private final boolean idle;

    public ChildLost(LossReason reason, Message said) {
        this(reason, said, false);
    }

    private ChildLost(LossReason reason, Message said, boolean idle) {
        super(said.toString());
        this.reason = reason;
        this.said = said;
        this.idle = idle;
    }

    /** Describes a child that used so much processor time and gave no answer. */
    public static ChildLost late(TimeLimit limit, Duration used) {
        boolean idle = used.multipliedBy(2).compareTo(limit.processor()) < 0;
        Message said =
                idle
                        ? Message.of("child.time.idle", Child.seconds(limit.wall()))
                        : Message.of("child.time", Child.seconds(limit.processor()));
        return new ChildLost(LossReason.TIME, said, idle);
    }

    /** Describes a child that sent what is no answer. */
    public static ChildLost protocol(Exception fault) {
        return new ChildLost(LossReason.PROTOCOL, Message.of("child.protocol", fault.getMessage()));
    }

    /**
     * Whether it used so little of its time that the machine may be to blame: to be tried again.
     */
    public boolean isIdle() {
        return idle;
    }

    public Message message() {
        return said;
    }

    public LossReason reason() {
        return reason;
    }

    /**
     * Whether the student's method may have had no part in it.
     *
     * @param again whether it happened in a second try, too
     */
    public boolean isOursToRepeat(boolean again) {
        return reason == LossReason.KILLED || (reason == LossReason.SIGNAL && !again);
    }
}
