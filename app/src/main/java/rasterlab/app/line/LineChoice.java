package rasterlab.app.line;

import rasterlab.engine.line.Segment;

/**
 * The user's choice, which undo brings back.
 *
 * @param method name of the method that draws
 * @param comparison name of a second method, "" for none
 */
public record LineChoice(Segment segment, String method, String comparison) {
    LineChoice with(Segment other) {
        return new LineChoice(other, method, comparison);
    }

    LineChoice withMethod(String other) {
        return new LineChoice(segment, other, comparison);
    }

    LineChoice withComparison(String other) {
        return new LineChoice(segment, method, other);
    }
}
