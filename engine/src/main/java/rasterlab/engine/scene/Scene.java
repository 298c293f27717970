package rasterlab.engine.scene;

import rasterlab.engine.transform.SphericalView;

/**
 * A mesh with its colours and the view it is first shown in.
 *
 * @param name lower-case with hyphens, as on the command line
 * @param mesh the faces
 * @param faceRgb one colour 0xRRGGBB per face
 * @param backgroundRgb the colour 0xRRGGBB behind the faces
 * @param defaultCamera the first view
 * @param pictureScale pixels per world unit, at the object's centre, in a picture of 800×600
 */
public record Scene(
        String name,
        Mesh mesh,
        int[] faceRgb,
        int backgroundRgb,
        SphericalView defaultCamera,
        double pictureScale) {
    public Scene {
        faceRgb = faceRgb.clone();
        if (faceRgb.length != mesh.faceCount())
            throw new IllegalArgumentException(
                    "scene '%s' needs one colour for each of %d faces, got %d"
                            .formatted(name, mesh.faceCount(), faceRgb.length));
        if (!(pictureScale > 0) || pictureScale == Double.POSITIVE_INFINITY)
            throw new IllegalArgumentException(
                    "scene '%s': picture scale must be finite and above 0, got %s"
                            .formatted(name, pictureScale));
    }

    /**
     * The same scene with its picture scale times {@code zoom}.
     *
     * @throws IllegalArgumentException unless zoom is finite and above 0
     */
    public Scene zoomed(double zoom) {
        if (!(zoom > 0 && zoom < Double.POSITIVE_INFINITY))
            throw new IllegalArgumentException("zoom must be finite and above 0, got " + zoom);
        return new Scene(name, mesh, faceRgb, backgroundRgb, defaultCamera, zoom * pictureScale);
    }

    /** A copy of the face colours. */
    @Override
    public int[] faceRgb() {
        return faceRgb.clone();
    }
}
