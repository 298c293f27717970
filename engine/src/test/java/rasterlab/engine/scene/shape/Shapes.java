package rasterlab.engine.scene.shape;

import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.joml.Matrix4d;
import org.junit.jupiter.params.provider.Arguments;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.geometry.Vector;

/** Every kind of shape, by name. */
final class Shapes {
    private Shapes() {}

    static Revolution spindle() {
        return new Revolution(
                new double[] {-1, 0, 0.5, 2},
                new double[] {0, 1, 0.7, 0},
                SplineEnds.slopes(1.5, -0.4),
                false,
                false);
    }

    static Revolution bottle() {
        return new Revolution(
                new double[] {-2, -1, 0, 1.5},
                new double[] {1, 1.4, 0.8, 1.1},
                SplineEnds.notAKnot(),
                true,
                true);
    }

    static Quad unevenQuad() {
        return new Quad(
                new Vector(0.3, -0.2, 0.9),
                new Vector(1, 0.5, 0.25),
                new Vector(-0.5, 2, 1),
                new TexturePlace(-1, 0.2),
                new TexturePlace(2.5, 0),
                new TexturePlace(2, 3),
                new TexturePlace(-0.5, 2));
    }

    static Placed leaningCan() {
        return new Placed(
                Cylinder.closed(1, 2),
                new Matrix4d().translate(3, -1, 2).rotateX(0.7).scale(1, 2, 0.5).rotateY(0.3));
    }

    static Stream<Arguments> closed() {
        return Stream.of(
                argumentSet("sphere", new Sphere(2)),
                argumentSet("closed cylinder", Cylinder.closed(1.5, 4)),
                argumentSet("torus", new Torus(2, 0.7)),
                argumentSet("thin torus", new Torus(3, 0.05)),
                argumentSet("cube", new Cube(3)),
                argumentSet("spindle", spindle()),
                argumentSet("bottle", bottle()),
                argumentSet("leaning, stretched can", leaningCan()));
    }

    static Stream<Arguments> all() {
        return Stream.concat(
                closed(),
                Stream.of(
                        argumentSet("open tube", Cylinder.open(0.8, 5)),
                        argumentSet("cup", new Cylinder(2, 1, true, false)),
                        argumentSet("uneven quad", unevenQuad()),
                        argumentSet("vase", Revolution.vase())));
    }
}
