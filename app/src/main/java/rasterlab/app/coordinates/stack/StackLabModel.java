package rasterlab.app.coordinates.stack;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.app.canvas.player.Steps;
import rasterlab.app.coordinates.figure.ChoiceModel;

/**
 * The lab of stacks without its window: which program, and how many of its commands are done. The
 * steps are the commands; the one done last is the one that can be edited.
 */
public final class StackLabModel extends ChoiceModel<StackChoice> implements Steps {
    private static final double TURN = 180;

    private int step = choice().commands().size();
    private StackScene scene = StackScene.of(choice().commands(), step);

    public StackLabModel() {
        super(StackChoice.first());
    }

    StackScene scene() {
        return scene;
    }

    /** Shows a program after its last command. */
    public void show(StackProgram program) {
        rearrange(choice().with(program.commands()));
        goTo(last());
    }

    /** Shows a program without commands. */
    public void clear() {
        change(choice().with(List.of()));
    }

    /** The command that was done last; empty before the first one. */
    Optional<StackCommand> newest() {
        return step == 0 ? Optional.empty() : Optional.of(choice().commands().get(step - 1));
    }

    /** Does a command now: behind those that are done. None beyond {@link StackChoice#MOST}. */
    public void add(StackOp op) {
        if (choice().commands().size() >= StackChoice.MOST) return;
        var commands = new ArrayList<>(choice().commands());
        commands.add(step, StackCommand.first(op));
        change(choice().with(commands));
        goTo(step + 1);
    }

    /** Takes the command that was done last out of the program. */
    public void remove() {
        if (step == 0) return;
        var commands = new ArrayList<>(choice().commands());
        commands.remove(step - 1);
        step--;
        change(choice().with(commands));
    }

    /** Sets another number for the newest command; one that is not allowed is an error of it. */
    public void set(int number, double value) {
        if (step == 0) return;
        var commands = new ArrayList<>(choice().commands());
        commands.set(step - 1, commands.get(step - 1).with(number, value));
        change(choice().with(commands));
    }

    /** Turns the viewpoint by shares of half a turn. */
    public void turn(double right, double up) {
        turnBy(TURN * right, -TURN * up);
    }

    public void turnBy(double alphaDegrees, double betaDegrees) {
        change(choice().with(choice().viewpoint().turned(alphaDegrees, betaDegrees)));
    }

    @Override
    protected void chosen(StackChoice next) {
        step = Math.min(step, next.commands().size());
        scene = StackScene.of(next.commands(), step);
    }

    @Override
    public int last() {
        return choice().commands().size();
    }

    @Override
    public int step() {
        return step;
    }

    @Override
    public void goTo(int next) {
        int inside = Math.max(0, Math.min(last(), next));
        if (inside == step) return;
        step = inside;
        scene = StackScene.of(choice().commands(), step);
        tell();
    }
}
