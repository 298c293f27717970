package rasterlab.engine.scene.shape;

/** Lengths of shapes, checked. */
final class Size {
    private Size() {}

    /**
     * Passes if the length lies between the smallest and the largest of shapes.
     *
     * @throws IllegalArgumentException naming it
     */
    static void require(String name, double length) {
        if (!(length >= SceneShape.SMALLEST && length <= SceneShape.LARGEST))
            throw new IllegalArgumentException(
                    "%s must be from %s to %s, got %s"
                            .formatted(name, SceneShape.SMALLEST, SceneShape.LARGEST, length));
    }

    /**
     * Passes if the coordinate is at most as far from 0 as shapes are large.
     *
     * @throws IllegalArgumentException naming it
     */
    static void requireCoordinate(String name, double coordinate) {
        if (!(Math.abs(coordinate) <= SceneShape.LARGEST))
            throw new IllegalArgumentException(
                    "%s must be from %s to %s, got %s"
                            .formatted(name, -SceneShape.LARGEST, SceneShape.LARGEST, coordinate));
    }
}
