package rasterlab.app.canvas.player;

/** Steps of a whole turn, played round and round. */
public abstract class TurnSteps implements Steps {
    private final int stepsInTurn;

    protected TurnSteps(int stepsInTurn) {
        this.stepsInTurn = stepsInTurn;
    }

    /** How far it has turned, in whole turns: any number. */
    protected abstract double turns();

    /**
     * @param turns in whole turns, in [0, 1)
     */
    protected abstract void turnTo(double turns);

    @Override
    public final int first() {
        return 0;
    }

    @Override
    public final int last() {
        return stepsInTurn - 1;
    }

    @Override
    public final int step() {
        return Math.floorMod(Math.round(turns() * stepsInTurn), stepsInTurn);
    }

    @Override
    public final void goTo(int step) {
        turnTo((double) within(step) / stepsInTurn);
    }

    @Override
    public final boolean turnsRound() {
        return true;
    }
}
