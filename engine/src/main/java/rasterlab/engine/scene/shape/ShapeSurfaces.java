package rasterlab.engine.scene.shape;

import java.util.List;
import rasterlab.engine.scene.ExactSurfaces;

/**
 * Shapes as the surfaces of a scene.
 *
 * @param shapes number i has finish i
 */
public record ShapeSurfaces(List<SceneShape> shapes) implements ExactSurfaces {
    public ShapeSurfaces {
        shapes = List.copyOf(shapes);
    }

    @Override
    public Caster caster() {
        return new ShapeCaster();
    }

    private final class ShapeCaster implements Caster {
        private final Ray ray = new Ray();

        @Override
        public int meet(double[] of, double least) {
            ray.aim(of[0], of[1], of[2], of[3], of[4], of[5], least);
            int met = -1;
            for (int i = 0; i < shapes.size(); i++) {
                double before = ray.t();
                shapes.get(i).meet(ray);
                if (ray.t() < before) met = i;
            }
            return met;
        }

        @Override
        public double distance() {
            return ray.t();
        }

        @Override
        public double place(int axis) {
            SurfacePoint point = ray.point();
            return axis == 0 ? point.x() : axis == 1 ? point.y() : point.z();
        }

        @Override
        public double normal(int axis) {
            SurfacePoint point = ray.point();
            return axis == 0 ? point.normalX() : axis == 1 ? point.normalY() : point.normalZ();
        }

        @Override
        public double textureS() {
            return ray.point().s();
        }

        @Override
        public double textureT() {
            return ray.point().t();
        }

        @Override
        public boolean fromInside() {
            return ray.fromInside();
        }
    }
}
