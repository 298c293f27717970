package rasterlab.engine.visibility.order;

/**
 * One step of a method that orders polygons.
 *
 * @param polygon number of the polygon that is painted, moved or cut, whole or a piece of it
 * @param against number of the polygon it is moved before or cut because of; its own where painted
 * @param value what decided: the method says what it is
 */
public record OrderStep(OrderStepKind kind, int polygon, int against, double value) {
    /** The kind of step that was done. */
    public enum OrderStepKind {
        PAINT,
        MOVE,
        CUT
    }

    static OrderStep paint(int polygon, double value) {
        return new OrderStep(OrderStepKind.PAINT, polygon, polygon, value);
    }
}
