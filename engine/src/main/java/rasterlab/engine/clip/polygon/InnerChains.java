package rasterlab.engine.clip.polygon;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.engine.clip.Fraction;

/**
 * Cuts a subject's boundary into the chains that run strictly inside a window.
 *
 * <p>An edge p→q is strictly inside where it is left of every side. A side that has p not to its
 * left and q to its left makes it enter there, the other way round leave; the last entering and the
 * first leaving count, compared without rounding where there are several.
 */
final class InnerChains {
    private final Ring window;
    private final Ring subject;
    private final SideCrossing crossing;
    private final List<InnerChain> chains = new ArrayList<>();
    private double[] corners = new double[16];
    private int size;
    private long sideTests;
    private RimPoint enter;

    InnerChains(Ring window, Ring subject) {
        this.window = window;
        this.subject = subject;
        crossing = new SideCrossing(window);
        int start = 0;
        while (start < subject.size() && inside(start)) start++;
        if (start == subject.size()) return;
        for (int i = 0; i < subject.size(); i++) edge((start + i) % subject.size());
    }

    /** The chains in the subject's order; none where its boundary never leaves or meets the rim. */
    List<InnerChain> chains() {
        return chains;
    }

    long sideTests() {
        return sideTests;
    }

    long unroundedCrossings() {
        return crossing.unrounded();
    }

    /** Whether a corner of the subject is strictly inside the window. */
    private boolean inside(int corner) {
        for (int side = 0; side < window.size(); side++) if (side(side, corner) <= 0) return false;
        return true;
    }

    private int side(int side, int corner) {
        sideTests++;
        return window.side(side, subject.x(corner), subject.y(corner));
    }

    private void edge(int from) {
        int enterSide = -1;
        int leaveSide = -1;
        Fraction entering = Fraction.ZERO;
        Fraction leaving = Fraction.ONE;
        for (int side = 0; side < window.size(); side++) {
            boolean fromLeft = side(side, from) > 0;
            boolean toLeft = side(side, from + 1) > 0;
            if (!fromLeft && !toLeft) return;
            if (fromLeft && toLeft) continue;
            Fraction share = share(side, from);
            if (toLeft && (enterSide < 0 || share.compareTo(entering) > 0)) {
                enterSide = side;
                entering = share;
            }
            if (fromLeft && (leaveSide < 0 || share.compareTo(leaving) < 0)) {
                leaveSide = side;
                leaving = share;
            }
        }
        if (enterSide >= 0 && leaveSide >= 0 && entering.compareTo(leaving) >= 0) return;
        if (enterSide >= 0) begin(point(enterSide, entering, from));
        if (leaveSide >= 0) end(point(leaveSide, leaving, from), from, leaving);
        else add(subject.x(from + 1), subject.y(from + 1));
    }

    private Fraction share(int side, int from) {
        return crossing.share(
                side, subject.x(from), subject.y(from), subject.x(from + 1), subject.y(from + 1));
    }

    private RimPoint point(int side, Fraction share, int from) {
        return RimPoint.of(
                window,
                side,
                share,
                subject.x(from),
                subject.y(from),
                subject.x(from + 1),
                subject.y(from + 1));
    }

    private void begin(RimPoint at) {
        enter = at;
        size = 0;
    }

    private void end(RimPoint at, int from, Fraction share) {
        boolean atCorner = share.compareTo(Fraction.ONE) == 0;
        boolean hollow = atCorner && subject.turn((from + 1) % subject.size()) < 0;
        chains.add(new InnerChain(enter, at, Arrays.copyOf(corners, size), hollow));
    }

    private void add(double x, double y) {
        if (size == corners.length) corners = Arrays.copyOf(corners, 2 * size);
        corners[size++] = x;
        corners[size++] = y;
    }
}
