package rasterlab.app.spline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.contract.Curve;
import rasterlab.engine.spline.curve.CurvePlace;

class CurveFormTest {
    private static final List<Place> ARCH =
            List.of(new Place(10, 200), new Place(61, 20), new Place(180, 43), new Place(250, 190));

    @Test
    void hermiteOfABezierCurveIsTheSameCurveAndBack() {
        List<Place> hermite = CurveForm.converted(CurveForm.BEZIER, ARCH, CurveForm.HERMITE);
        assertEquals(new Place(153, -540), hermite.get(2));
        assertEquals(new Place(210, 441), hermite.get(3));
        Curve before = CurveForm.BEZIER.curves(ARCH).get(0);
        Curve after = CurveForm.HERMITE.curves(hermite).get(0);
        for (double t = 0; t <= 1; t += 0.125) {
            assertEquals(CurvePlace.at(before, t).x(), CurvePlace.at(after, t).x(), 1e-9);
            assertEquals(CurvePlace.at(before, t).y(), CurvePlace.at(after, t).y(), 1e-9);
        }
        List<Place> back = CurveForm.converted(CurveForm.HERMITE, hermite, CurveForm.BEZIER);
        for (int i = 0; i < 4; i++) assertTrue(back.get(i).distance(ARCH.get(i)) < 1e-9, "" + back);
    }

    @ParameterizedTest(name = "{0} opens as another form cannot")
    @EnumSource(CurveForm.class)
    void everyFormCanBecomeEveryOther(CurveForm from) {
        for (CurveForm to : CurveForm.values()) {
            List<Place> points = CurveForm.converted(from, FirstCurves.points(from), to);
            assertTrue(!to.curves(points).isEmpty(), from + " to " + to);
            assertEquals(points.size(), to.handles(points).size());
        }
    }

    @Test
    void piecesTouchAtEveryThirdPoint() {
        List<Curve> pieces = CurveForm.PIECES.curves(FirstCurves.points(CurveForm.PIECES));
        assertEquals(3, pieces.size());
        assertEquals(pieces.get(0).x()[3], pieces.get(1).x()[0]);
        assertEquals(pieces.get(1).y()[3], pieces.get(2).y()[0]);
    }

    @Test
    void handleOfADerivativeIsAThirdOfIt() {
        List<Place> points = FirstCurves.points(CurveForm.HERMITE);
        Place handle = CurveForm.HERMITE.handles(points).get(2);
        assertEquals(points.get(0).x() + points.get(2).x() / 3, handle.x(), 1e-9);
        List<Place> moved =
                CurveForm.HERMITE.moved(points, 3, new Place(530.1, 250), CurveJoining.C0);
        Place end = moved.get(1);
        assertEquals(3 * (530.1 - end.x()), moved.get(3).x(), 1e-9);
        assertEquals(moved.get(3).x(), Math.rint(moved.get(3).x() * 1e4) / 1e4, "noise");
    }
}
