package rasterlab.app.coordinates.stack;

import java.util.List;
import rasterlab.app.coordinates.figure.Viewpoint;

/**
 * What the user chose, and what undo brings back.
 *
 * @param commands the program
 * @param selected number of a command, from 0; −1 where there is none
 */
public record StackChoice(List<StackCommand> commands, int selected, Viewpoint viewpoint) {
    /** The most commands of a program: enough to fill the deepest stack and to empty it. */
    public static final int MOST = 100;

    public StackChoice {
        commands = List.copyOf(commands);
    }

    static StackChoice first() {
        return new StackChoice(StackProgram.ARM.commands(), 0, Viewpoint.FIRST);
    }

    StackChoice with(List<StackCommand> others, int chosen) {
        int least = others.isEmpty() ? -1 : 0;
        return new StackChoice(
                others, Math.max(least, Math.min(others.size() - 1, chosen)), viewpoint);
    }

    StackChoice with(Viewpoint other) {
        return new StackChoice(commands, selected, other);
    }
}
