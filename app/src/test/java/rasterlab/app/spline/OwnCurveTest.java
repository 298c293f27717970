package rasterlab.app.spline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.spline.curve.Sampling;
import rasterlab.exercises.catalogue.Catalogue;

class OwnCurveTest {
    private static OwnCurve asked(String exercise) {
        return new OwnCurve(Catalogue.builtIn().named(exercise));
    }

    @ParameterizedTest(name = "a program for {0} is asked for what its contract lacks")
    @CsvSource({"bezier-point, false", "hermite, false", "flatten-curve, true"})
    void aProgramIsAskedForWhatItsContractHas(String exercise, boolean flat) {
        Sampling steps = Sampling.equal(7);
        Sampling polyline = Sampling.flat(2);
        assertEquals(flat, asked(exercise).sampling(polyline).isFlat());
        assertEquals(flat, asked(exercise).sampling(steps).isFlat());
        Sampling fits = flat ? polyline : steps;
        assertEquals(fits, asked(exercise).sampling(fits), "what can be asked is left");
    }

    @ParameterizedTest(name = "a program for {0} is asked for a curve of kind {1}")
    @CsvSource({
        "hermite, BEZIER, HERMITE",
        "hermite, HERMITE, HERMITE",
        "bezier-point, HERMITE, BEZIER",
        "bezier-point, PIECES, PIECES"
    })
    void aProgramIsAskedForCurvesOfItsCases(String exercise, CurveForm shown, CurveForm asked) {
        assertEquals(asked, asked(exercise).form(shown));
    }
}
