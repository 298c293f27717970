package rasterlab.engine.scene;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import rasterlab.engine.transform.SphericalView;

/**
 * A mesh with its looks, its light and the view it is first shown in.
 *
 * @param name lower-case with hyphens, as on the command line
 * @param mesh the faces
 * @param finishes what faces can look like
 * @param finishOf which of {@code finishes} each face has
 * @param light what shines on them
 * @param backgroundRgb the colour 0xRRGGBB behind the faces
 * @param defaultCamera the first view
 * @param pictureScale pixels per world unit, at the object's centre, in a picture of 800×600
 * @param surfaces what the faces stand for, where it is known; all finishes are theirs, in order
 */
public record Scene(
        String name,
        Mesh mesh,
        List<Appearance> finishes,
        int[] finishOf,
        SceneLight light,
        int backgroundRgb,
        SphericalView defaultCamera,
        double pictureScale,
        Optional<ExactSurfaces> surfaces) {
    public Scene {
        finishes = List.copyOf(finishes);
        finishOf = finishOf.clone();
        if (finishOf.length != mesh.faceCount())
            throw new IllegalArgumentException(
                    "scene '%s' needs one finish for each of %d faces, got %d"
                            .formatted(name, mesh.faceCount(), finishOf.length));
        for (int f = 0; f < finishOf.length; f++)
            if (finishOf[f] < 0 || finishOf[f] >= finishes.size())
                throw new IllegalArgumentException(
                        "scene '%s', face %d: finish must be from 0 to %d, got %d"
                                .formatted(name, f, finishes.size() - 1, finishOf[f]));
        if (!(pictureScale > 0) || pictureScale == Double.POSITIVE_INFINITY)
            throw new IllegalArgumentException(
                    "scene '%s': picture scale must be finite and above 0, got %s"
                            .formatted(name, pictureScale));
    }

    /** A scene of faces that stand for nothing but themselves. */
    public Scene(
            String name,
            Mesh mesh,
            List<Appearance> finishes,
            int[] finishOf,
            SceneLight light,
            int backgroundRgb,
            SphericalView defaultCamera,
            double pictureScale) {
        this(
                name,
                mesh,
                finishes,
                finishOf,
                light,
                backgroundRgb,
                defaultCamera,
                pictureScale,
                Optional.empty());
    }

    /** This scene, its faces standing for surfaces. */
    public Scene of(ExactSurfaces exact) {
        return new Scene(
                name,
                mesh,
                finishes,
                finishOf,
                light,
                backgroundRgb,
                defaultCamera,
                pictureScale,
                Optional.of(exact));
    }

    /**
     * A scene of dull faces with a lamp at the eye.
     *
     * @param faceRgb one colour 0xRRGGBB per face
     */
    public static Scene dull(
            String name,
            Mesh mesh,
            int[] faceRgb,
            int backgroundRgb,
            SphericalView defaultCamera,
            double pictureScale) {
        int[] colors = Arrays.stream(faceRgb).distinct().toArray();
        List<Appearance> finishes = Arrays.stream(colors).mapToObj(Appearance::dull).toList();
        int[] finishOf =
                Arrays.stream(faceRgb)
                        .map(rgb -> Arrays.stream(colors).boxed().toList().indexOf(rgb))
                        .toArray();
        return new Scene(
                name,
                mesh,
                finishes,
                finishOf,
                SceneLight.lampAtEye(),
                backgroundRgb,
                defaultCamera,
                pictureScale);
    }

    /**
     * This scene with its picture scale times {@code zoom}.
     *
     * @throws IllegalArgumentException unless zoom is finite and above 0
     */
    public Scene zoomed(double zoom) {
        if (!(zoom > 0 && zoom < Double.POSITIVE_INFINITY))
            throw new IllegalArgumentException("zoom must be finite and above 0, got " + zoom);
        return new Scene(
                name,
                mesh,
                finishes,
                finishOf,
                light,
                backgroundRgb,
                defaultCamera,
                zoom * pictureScale,
                surfaces);
    }

    /** This scene first seen from elsewhere. */
    public Scene seenFrom(SphericalView camera) {
        return new Scene(
                name,
                mesh,
                finishes,
                finishOf,
                light,
                backgroundRgb,
                camera,
                pictureScale,
                surfaces);
    }

    /** This scene with some of its faces only, in the order given. */
    public Scene only(int[] faces) {
        return new Scene(
                name,
                MeshPart.of(mesh, faces),
                finishes,
                Arrays.stream(faces).map(face -> finishOf[face]).toArray(),
                light,
                backgroundRgb,
                defaultCamera,
                pictureScale,
                surfaces);
    }

    /** This scene with other finishes, one for each of its own. */
    public Scene with(UnaryOperator<Appearance> change) {
        return new Scene(
                name,
                mesh,
                finishes.stream().map(change).toList(),
                finishOf,
                light,
                backgroundRgb,
                defaultCamera,
                pictureScale,
                surfaces);
    }

    /** Which of the finishes a face has. */
    public int finishNumber(int face) {
        return finishOf[face];
    }

    /** The look of a face. */
    public Appearance finish(int face) {
        return finishes.get(finishOf[face]);
    }

    /** A copy of the faces' finishes. */
    @Override
    public int[] finishOf() {
        return finishOf.clone();
    }
}
