package rasterlab.engine.study;

import rasterlab.engine.format.InvalidInput;

/**
 * One call of a method from outside.
 *
 * @param name of the method, for messages
 * @param steps whether the answer has the recorded walk too
 * @param <C> the contract of the method
 */
public record Call<C>(String name, C method, boolean steps) {
    /**
     * The method as one with steps.
     *
     * @throws InvalidInput if it has none
     */
    public <S> S stepped(Class<S> type) {
        if (!type.isInstance(method)) throw noSteps();
        return type.cast(method);
    }

    /** A complaint that the method has no steps, which were asked for. */
    public InvalidInput noSteps() {
        return new InvalidInput("--steps", "method '" + name + "' has no steps");
    }
}
