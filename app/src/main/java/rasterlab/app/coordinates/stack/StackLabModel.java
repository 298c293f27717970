package rasterlab.app.coordinates.stack;

import java.util.ArrayList;
import rasterlab.app.canvas.Steps;
import rasterlab.app.coordinates.figure.ChoiceModel;

/**
 * The lab of stacks without its window: which program, and how many of its commands are done. The
 * steps are the commands.
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
        rearrange(choice().with(program.commands(), program.commands().size() - 1));
        goTo(last());
    }

    /** A program without commands. */
    public void clear() {
        change(choice().with(new ArrayList<>(), -1));
    }

    /**
     * Does a command now: behind those that are done. None beyond {@link StackChoice#MOST}.
     */
    public void add(StackOp op) {
        StackChoice now = choice();
        if (now.commands().size() >= StackChoice.MOST) return;
        var commands = new ArrayList<>(now.commands());
        int at = step;
        commands.add(at, StackCommand.first(op));
        change(now.with(commands, at));
        goTo(at + 1);
    }

    /** Takes the selected command out of the program. */
    public void remove() {
        StackChoice now = choice();
        if (now.selected() < 0) return;
        var commands = new ArrayList<>(now.commands());
        commands.remove(now.selected());
        boolean done = now.selected() < step;
        change(now.with(commands, now.selected()));
        if (done) goTo(step - (step > commands.size() ? 0 : 1));
    }

    /** Selects a command and goes to where it is just done. */
    public void select(int index) {
        pass(choice().with(choice().commands(), index));
        goTo(index + 1);
    }

    /** Another number for the selected command; one that is not allowed is an error of it. */
    public void set(int number, double value) {
        StackChoice now = choice();
        var commands = new ArrayList<>(now.commands());
        commands.set(now.selected(), commands.get(now.selected()).with(number, value));
        change(now.with(commands, now.selected()));
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
    public int first() {
        return 0;
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

    @Override
    public boolean turnsRound() {
        return false;
    }
}
