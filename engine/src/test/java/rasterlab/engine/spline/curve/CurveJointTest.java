package rasterlab.engine.spline.curve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.Curve;

class CurveJointTest {
    /** The first piece ends at (90, 0), coming from (60, 30): its derivative is (90, −90). */
    private static final Curve FIRST = bezier(0, 0, 30, 30, 60, 30, 90, 0);

    static Stream<Arguments> joints() {
        return Stream.of(
                argumentSet(
                        "a gap is not seen", CurveJoint.Continuity.GAP, 91, 0, 120, -30, 150, -30),
                argumentSet("a corner passes", CurveJoint.Continuity.C0, 90, 0, 120, 30, 150, 30),
                argumentSet("turning back passes", CurveJoint.Continuity.C0, 90, 0, 60, 30, 30, 30),
                argumentSet(
                        "standing still passes", CurveJoint.Continuity.C0, 90, 0, 90, 0, 150, -30),
                argumentSet(
                        "a jump in speed passes",
                        CurveJoint.Continuity.G1,
                        90,
                        0,
                        100,
                        -10,
                        150,
                        0),
                argumentSet(
                        "a jump in bend passes", CurveJoint.Continuity.C1, 90, 0, 120, -30, 150, 0),
                argumentSet(
                        "rounding is a jump", CurveJoint.Continuity.C2, 90, 0, 120, -30, 150, -90));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("joints")
    void tellsHowPiecesJoin(
            CurveJoint.Continuity kind,
            double x0,
            double y0,
            double x1,
            double y1,
            double x2,
            double y2) {
        Curve next = bezier(x0, y0, x1, y1, x2, y2, 200, 7);
        assertEquals(kind, joint(FIRST, 0, next, 0).kind());
    }

    @Test
    void spansOfEachKindJoinAsItsNamePromises() {
        double[] x = {0, 40, 90, 160, 110, 30};
        double[] y = {0, 200, 10, 90, 20, 300};
        var through = new Curve(Curve.Kind.CATMULL_ROM, x, y);
        var drawn = new Curve(Curve.Kind.B_SPLINE, x, y);
        for (int span = 0; span < 2; span++) {
            assertEquals(
                    CurveJoint.Continuity.C1,
                    joint(through, span, through, span + 1).kind(),
                    "" + span);
            assertEquals(
                    CurveJoint.Continuity.C2,
                    joint(drawn, span, drawn, span + 1).kind(),
                    "" + span);
        }
    }

    @Test
    void turnIsTheAngleBetweenTheDirections() {
        Curve next = bezier(90, 0, 120, 30, 150, 30, 200, 7);
        assertEquals(Math.PI / 2, joint(FIRST, 0, next, 0).turnRadians(), 1e-12);
        assertEquals(0, joint(FIRST, 0, next, 0).gap());
        Curve still = bezier(90, 0, 90, 0, 150, 30, 200, 7);
        assertTrue(Double.isNaN(joint(FIRST, 0, still, 0).turnRadians()));
    }

    private static CurveJoint joint(Curve before, int span, Curve after, int next) {
        return new CurveJoint(CurvePlace.of(before, span, 1), CurvePlace.of(after, next, 0));
    }

    private static Curve bezier(double... coordinates) {
        var x = new double[4];
        var y = new double[4];
        for (int i = 0; i < 4; i++) {
            x[i] = coordinates[2 * i];
            y[i] = coordinates[2 * i + 1];
        }
        return new Curve(Curve.Kind.BEZIER, x, y);
    }
}
