package rasterlab.app.coordinates.stack;

import java.util.List;
import rasterlab.app.coordinates.figure.Viewpoint;

/**
 * The user's choice, which undo brings back.
 *
 * @param commands the program
 */
public record StackChoice(List<StackCommand> commands, Viewpoint viewpoint) {
    /** The most commands of a program: enough to fill the deepest stack and to empty it. */
    public static final int MOST = 100;

    public StackChoice {
        commands = List.copyOf(commands);
    }

    static StackChoice first() {
        return new StackChoice(StackProgram.ARM.commands(), Viewpoint.FIRST);
    }

    StackChoice with(List<StackCommand> others) {
        return new StackChoice(others, viewpoint);
    }

    StackChoice with(Viewpoint other) {
        return new StackChoice(commands, other);
    }
}
