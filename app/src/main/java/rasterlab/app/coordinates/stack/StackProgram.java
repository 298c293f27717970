package rasterlab.app.coordinates.stack;

import static rasterlab.app.coordinates.stack.StackOp.*;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** Programs that show what stacks are for, and where they end. */
public enum StackProgram {
    /** An arm of three links: each hangs on the one before, its thickness on none. */
    ARM(arm(true)),
    /** An arm without Push and Pop: the first link's thickness is that of all. */
    FORGOTTEN_PUSH(arm(false)),
    /** Four spokes, each from the same hub. */
    SPOKES(spokes()),
    /** The projection's stack holds two matrices. */
    OVERFLOW(
            List.of(
                    op(PROJECTION),
                    op(PERSPECTIVE, 40, 1.5, 1, 50),
                    op(PUSH),
                    op(IDENTITY),
                    op(PUSH))),
    /** One Pop too many. */
    UNDERFLOW(List.of(op(PUSH), op(TRANSLATE, 2, 0, 0), op(CUBE), op(POP), op(CUBE), op(POP))),
    /** No direction to turn about. */
    NO_AXIS(List.of(op(ROTATE, 30, 0, 0, 0), op(CUBE))),
    /** Opposite sides that are one. */
    NO_WIDTH(List.of(op(PROJECTION), op(FRUSTUM, 1, 1, -1, 1, 2, 50))),
    /** A matrix as it is read: far left, numbers column by column. */
    LOADED(List.of(op(LOAD, 0, 2, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1), op(CUBE)));

    private final transient List<StackCommand> commands;

    StackProgram(List<StackCommand> commands) {
        this.commands = commands;
    }

    private static StackCommand op(StackOp op, double... numbers) {
        return StackCommand.of(op, numbers);
    }

    private static List<StackCommand> arm(boolean kept) {
        var commands = new ArrayList<>(Arrays.asList(op(ROTATE, 25, 0, -1, 0)));
        for (int link = 0; link < 3; link++) {
            if (link > 0) {
                commands.add(op(TRANSLATE, 4, 0, 0));
                commands.add(op(ROTATE, link == 1 ? 40 : -50, 0, -1, 0));
            }
            if (kept) commands.add(op(PUSH));
            commands.add(op(SCALE, 4, 1, 1 - 0.25 * link));
            commands.add(op(CUBE));
            if (kept) commands.add(op(POP));
        }
        return List.copyOf(commands);
    }

    private static List<StackCommand> spokes() {
        var commands = new ArrayList<StackCommand>();
        for (int spoke = 0; spoke < 4; spoke++) {
            commands.add(op(PUSH));
            commands.add(op(ROTATE, 90.0 * spoke, 0, 0, 1));
            commands.add(op(TRANSLATE, 2, -0.5, 0));
            commands.add(op(SCALE, 3, 1, 1));
            commands.add(op(CUBE));
            commands.add(op(POP));
        }
        return List.copyOf(commands);
    }

    List<StackCommand> commands() {
        return commands;
    }

    /** Lower-case name with hyphens. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
