package rasterlab.app.light;

import java.util.Arrays;
import java.util.Optional;
import rasterlab.app.light.step.NormalSteps;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.mine.OwnProgram;
import rasterlab.contract.VertexNormals;
import rasterlab.engine.light.UnitVector;
import rasterlab.engine.light.normals.NormalsTopic;
import rasterlab.engine.light.normals.TriangleSurface;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.study.WrongLength;
import rasterlab.engine.transform.Images;

/**
 * A body with the normals that the user's own program finds.
 *
 * @param scene with the scene's own normals where the program gave none
 * @param right the same with the normals that its exercise asks for
 * @param remarks what there is to say of them
 */
record OwnNormals(Scene scene, Scene right, OwnRemarks remarks) {
    static final String TOPIC = new NormalsTopic().name();

    /** The tolerance of normals where the program's exercise gives none. */
    private static final String USUAL = "angle";

    /** A tip that is nearer is in its place. */
    private static final double RIGHT = 1e-9;

    /** Asks the program for its normals, once and on any thread. */
    static OwnNormals of(LitBody body, OwnMethods own) {
        var asked = new ObservedNormals(own);
        VertexNormals truth = new NormalsTopic().method(truth(own)).implementation();
        Scene right = body.scene(truth);
        try {
            return new OwnNormals(body.scene(asked), right, asked.remarks(truth));
        } catch (WrongLength length) {
            return refused(body, right, OwnMethods.misshapen(length));
        } catch (IllegalArgumentException refusal) {
            return refused(body, right, refusal);
        }
    }

    private static OwnNormals refused(LitBody body, Scene right, IllegalArgumentException refusal) {
        return new OwnNormals(body.scene(), right, OwnRemarks.refused(refusal.getMessage()));
    }

    private static String truth(OwnMethods own) {
        Optional<OwnProgram> program = own.of(TOPIC);
        return program.flatMap(one -> one.exercise().tolerance().truth()).orElse(USUAL);
    }

    /** The program, whose normals are made usable: of length 1, or none. */
    private static final class ObservedNormals implements VertexNormals {
        private final NormalsTopic topic = new NormalsTopic();
        private final VertexNormals program;
        private TriangleSurface surface;
        private Images found;

        ObservedNormals(OwnMethods own) {
            program = own.in(topic).method(OwnMethods.NAME).implementation();
        }

        @Override
        public double[] normals(double[] vertices, int[] triangles) {
            surface = new TriangleSurface(vertices, triangles);
            found = topic.record(program, surface, Integer.MAX_VALUE);
            var usable = new double[found.coordinates().length];
            for (int i = 0; i < found.size(); i++) {
                double[] one = Arrays.copyOfRange(found.coordinates(), 3 * i, 3 * i + 3);
                if (found.has(i) && UnitVector.normalize(one))
                    System.arraycopy(one, 0, usable, 3 * i, 3);
            }
            return usable;
        }

        /** Holds what it answered against the right normals. */
        OwnRemarks remarks(VertexNormals truth) {
            Images exact = topic.record(truth, surface, Integer.MAX_VALUE);
            Optional<OwnRemarks.WrongNormal> first = Optional.empty();
            long wrong = 0;
            for (int v = 0; v < exact.size(); v++) {
                double[] mine = Arrays.copyOfRange(found.coordinates(), 3 * v, 3 * v + 3);
                double[] right = Arrays.copyOfRange(exact.coordinates(), 3 * v, 3 * v + 3);
                if (apart(mine, right) <= RIGHT) continue;
                if (wrong++ == 0) first = Optional.of(new OwnRemarks.WrongNormal(v, mine, right));
            }
            return OwnRemarks.ofNormals(wrong, exact.size(), first, steps(exact));
        }

        private NormalSteps steps(Images exact) {
            return NormalSteps.of(
                    surface.vertices(),
                    surface.triangles(),
                    found.coordinates(),
                    exact.coordinates());
        }

        private static double apart(double[] mine, double[] right) {
            var between = new double[3];
            for (int axis = 0; axis < 3; axis++) between[axis] = mine[axis] - right[axis];
            double apart = UnitVector.length(between);
            return Double.isNaN(apart) ? Double.POSITIVE_INFINITY : apart;
        }
    }
}
