package rasterlab.engine.visibility.faces;

import java.util.Map;

/**
 * The segment method as the course tells it: a face is visible where its plane cuts the segment
 * from the eye A to a point B between the two, and not where the line is parallel to it.
 *
 * <p>Nothing is asked of the body or of B, the plane is that of the first three corners, and all is
 * rounded.
 */
final class ConvexSegmentTextbook implements SteppedVisibleFaces {
    @Override
    public FaceWalk walk(Body body) {
        return new Walk(body);
    }

    @Override
    public String decision() {
        return "μ = (c − n·A) / (n·(B − A)) of the plane on the segment from the eye A to the"
                + " inner point B, visible between 0 and 1";
    }

    private static final class Walk implements FaceWalk {
        private final double[] xyz;
        private final int[][] faces;
        private final double[] eye;
        private final double[] inside;
        private int face = -1;
        private double mu;

        Walk(Body body) {
            xyz = body.xyz();
            faces = body.faces();
            eye = body.eye();
            inside = body.insideOrMean();
        }

        @Override
        public boolean advance() {
            if (face + 1 == faces.length) return false;
            face++;
            int p = 3 * faces[face][0];
            int q = 3 * faces[face][1];
            int r = 3 * faces[face][2];
            double rise = 0;
            double slope = 0;
            for (int axis = 0; axis < 3; axis++) {
                int next = (axis + 1) % 3;
                int last = (axis + 2) % 3;
                double normal =
                        (xyz[q + next] - xyz[p + next]) * (xyz[r + last] - xyz[p + last])
                                - (xyz[q + last] - xyz[p + last]) * (xyz[r + next] - xyz[p + next]);
                rise += normal * (xyz[p + axis] - eye[axis]);
                slope += normal * (inside[axis] - eye[axis]);
            }
            mu = rise / slope;
            return true;
        }

        @Override
        public int face() {
            return face;
        }

        /**
         * Whether μ is between 0 and 1; not where the line is parallel: μ is infinite there, or no
         * number.
         */
        @Override
        public boolean visible() {
            return mu > 0 && mu < 1;
        }

        @Override
        public double value() {
            return mu;
        }

        @Override
        public Map<String, Long> operations() {
            return Map.of("lines met", face + 1L);
        }
    }
}
