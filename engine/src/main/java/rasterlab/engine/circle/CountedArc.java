package rasterlab.engine.circle;

/** A walk that counts its choices itself, because its pixels do not show all of them. */
abstract class CountedArc implements ArcWalk {
    long choices;
    long asides;
    long downs;

    final ArcCount drain() {
        boolean more = advance();
        while (more) more = advance();
        return new ArcCount(choices, asides, downs);
    }
}
