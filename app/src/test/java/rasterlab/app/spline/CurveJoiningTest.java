package rasterlab.app.spline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.spline.curve.Joint;
import rasterlab.engine.spline.curve.CurveJoint;

class CurveJoiningTest {
    private static final List<Place> POINTS = FirstCurves.points(CurveForm.PIECES);
    private static final Place AWAY = new Place(187, 233);

    static Stream<Arguments> kept() {
        return Stream.of(
                argumentSet("handle before the joint breaks G1", CurveJoining.G1, 2),
                argumentSet("handle behind the joint breaks G1", CurveJoining.G1, 4),
                argumentSet("handle before the joint breaks C1", CurveJoining.C1, 5),
                argumentSet("handle behind the joint breaks C1", CurveJoining.C1, 7),
                argumentSet("joint leaves its handles behind", CurveJoining.C1, 3),
                argumentSet("first handle has no joint", CurveJoining.C1, 1),
                argumentSet("last point has no handle behind", CurveJoining.C1, 9));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("kept")
    void jointsStayAsSmoothWhenAPointMoves(CurveJoining joining, int point) {
        List<Place> joined = joining.everywhere(POINTS);
        List<Place> moved = joining.moved(joined, point, AWAY);
        assertEquals(AWAY, moved.get(point));
        for (Joint joint : Joint.all(CurveForm.PIECES.curves(moved)))
            assertTrue(
                    joint.kind().compareTo(CurveJoint.Continuity.valueOf(joining.name())) >= 0,
                    joint.toString());
    }

    @Test
    void g1KeepsTheLengthOfTheOtherHandleAndC1DoesNot() {
        double before = POINTS.get(3).distance(POINTS.get(4));
        List<Place> turned = CurveJoining.G1.moved(POINTS, 2, AWAY);
        assertEquals(before, turned.get(3).distance(turned.get(4)), 1e-6);
        List<Place> equal = CurveJoining.C1.moved(POINTS, 2, AWAY);
        assertEquals(AWAY.distance(POINTS.get(3)), equal.get(3).distance(equal.get(4)), 1e-6);
    }

    @Test
    void c0MovesOnlyWhatIsHeld() {
        List<Place> moved = CurveJoining.C0.moved(POINTS, 2, AWAY);
        for (int i = 0; i < POINTS.size(); i++)
            assertEquals(i == 2 ? AWAY : POINTS.get(i), moved.get(i), "point " + i);
        assertEquals(
                CurveJoint.Continuity.C0, Joint.all(CurveForm.PIECES.curves(moved)).get(0).kind());
    }

    @Test
    void handleInItsJointTurnsNothing() {
        List<Place> moved = CurveJoining.G1.moved(POINTS, 2, POINTS.get(3));
        assertEquals(POINTS.get(4), moved.get(4));
    }
}
