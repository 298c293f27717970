package rasterlab.engine.visibility.faces;

import java.util.Map;

/**
 * A face is turned towards the eye where the eye is in front of its plane: n·(eye − c₀) &gt; 0.
 *
 * <p>It judges each face by itself and needs neither an inner point nor a convex body; what a
 * convex one shows is decided by this alone.
 *
 * <p>Source: L. G. Roberts, Machine perception of three-dimensional solids, 1963.
 */
final class BackFace implements SteppedVisibleFaces {
    @Override
    public FaceWalk walk(Body body) {
        return new Walk(body);
    }

    @Override
    public String decision() {
        return "2·n·(eye − c₀), visible above 0";
    }

    private static final class Walk implements FaceWalk {
        private final int[][] faces;
        private final double[] eye;
        private final FaceSide side;
        private int face = -1;
        private boolean visible;

        Walk(Body body) {
            faces = body.faces();
            eye = body.eye();
            side = new FaceSide(body.xyz());
        }

        @Override
        public boolean advance() {
            if (face + 1 == faces.length) return false;
            face++;
            visible = side.of(faces[face], eye[0], eye[1], eye[2]) > 0;
            return true;
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
            return side.value();
        }

        @Override
        public Map<String, Long> operations() {
            return Map.of("sides asked", side.asked(), "sides asked exactly", side.exactly());
        }
    }
}
