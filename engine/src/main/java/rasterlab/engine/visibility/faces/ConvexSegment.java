package rasterlab.engine.visibility.faces;

import java.util.Arrays;
import java.util.Map;

/**
 * The segment from the eye A to an inner point B crosses the planes of the faces that A sees: A and
 * B are on two sides of such a plane.
 *
 * <p>That holds where B is behind every face, as an inner point of a convex body is; it is checked
 * for each face, exactly, and a body or a point for which it does not hold is refused. Of bodies
 * that are not convex those are left in whose inner point all faces can be seen from the inside.
 */
final class ConvexSegment implements SteppedVisibleFaces {
    @Override
    public FaceWalk walk(Body body) {
        return new Walk(body);
    }

    @Override
    public String decision() {
        return "μ = (c − n·A) / (n·(B − A)) of the plane on the segment from the eye A to the"
                + " inner point B, visible where A and B are on two sides";
    }

    private static final class Walk implements FaceWalk {
        private final int[][] faces;
        private final double[] eye;
        private final double[] inside;
        private final FaceSide side;
        private int face = -1;
        private boolean visible;
        private double mu;

        Walk(Body body) {
            faces = body.faces();
            eye = body.eye();
            inside = body.insideOrMean();
            side = new FaceSide(body.xyz());
        }

        @Override
        public boolean advance() {
            if (face + 1 == faces.length) return false;
            face++;
            int[] corners = faces[face];
            int ofInside = side.of(corners, inside[0], inside[1], inside[2]);
            if (ofInside >= 0) throw refusal(ofInside);
            double atB = side.value();
            visible = side.of(corners, eye[0], eye[1], eye[2]) > 0;
            mu = side.value() / (side.value() - atB);
            return true;
        }

        private IllegalArgumentException refusal(int ofInside) {
            return new IllegalArgumentException(
                    "inside must be behind every face, but %s lies %s face %d; give an inner point of"
                                    .formatted(
                                            Arrays.toString(inside),
                                            ofInside > 0 ? "in front of" : "in the plane of",
                                            face)
                            + " a convex body, its faces counter-clockwise seen from outside");
        }

        @Override
        public int face() {
            return face;
        }

        @Override
        public boolean visible() {
            return visible;
        }

        @Override
        public double value() {
            return mu;
        }

        @Override
        public Map<String, Long> operations() {
            return Map.of("sides asked", side.asked(), "sides asked exactly", side.exactly());
        }
    }
}
