package rasterlab.app.light;

import java.util.Arrays;
import java.util.Optional;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.mine.OwnProgram;
import rasterlab.contract.VertexNormals;
import rasterlab.engine.light.UnitVector;
import rasterlab.engine.light.normals.NormalsTopic;
import rasterlab.engine.light.normals.Triangles;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.WrongLength;
import rasterlab.engine.transform.Images;

/**
 * A body with the normals that the user's own program finds.
 *
 * @param scene with the scene's own normals where the program gave none
 * @param told what there is to say of them
 */
record OwnNormals(Scene scene, OwnTold told) {
    static final String TOPIC = new NormalsTopic().name();

    /** What normals are held against where the program's exercise does not say. */
    private static final String USUAL = "angle";

    /** A tip that is nearer is in its place. */
    private static final double RIGHT = 1e-9;

    /** On any thread; the program is asked once. */
    static OwnNormals of(Body body, OwnMethods own) {
        var asked = new Asked(own);
        try {
            Scene scene = body.scene(asked);
            return new OwnNormals(scene, OwnTold.ofNormals(asked.off(truth(own)), RIGHT));
        } catch (WrongLength length) {
            return refused(body, OwnMethods.misshapen(length));
        } catch (IllegalArgumentException refusal) {
            return refused(body, refusal);
        }
    }

    private static OwnNormals refused(Body body, IllegalArgumentException refusal) {
        return new OwnNormals(body.scene(), OwnTold.refused(refusal.getMessage()));
    }

    private static String truth(OwnMethods own) {
        Optional<OwnProgram> program = own.of(TOPIC);
        return program.flatMap(one -> one.exercise().tolerance().truth()).orElse(USUAL);
    }

    /** The program, whose normals are made usable: of length 1, or none. */
    private static final class Asked implements VertexNormals {
        private final NormalsTopic topic = new NormalsTopic();
        private final VertexNormals program;
        private Triangles surface;
        private Images found;

        Asked(OwnMethods own) {
            program = own.in(topic).method(OwnMethods.NAME).implementation();
        }

        @Override
        public double[] normals(double[] vertices, int[] triangles) {
            surface = new Triangles(vertices, triangles);
            found = topic.record(program, surface, Integer.MAX_VALUE);
            var usable = new double[found.coordinates().length];
            for (int i = 0; i < found.size(); i++) {
                double[] one = Arrays.copyOfRange(found.coordinates(), 3 * i, 3 * i + 3);
                if (found.has(i) && UnitVector.normalise(one))
                    System.arraycopy(one, 0, usable, 3 * i, 3);
            }
            return usable;
        }

        Deviation off(String truth) {
            VertexNormals right = topic.method(truth).implementation();
            Images exact = topic.record(right, surface, Integer.MAX_VALUE);
            return topic.compare(surface, exact, found);
        }
    }
}
