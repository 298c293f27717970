package rasterlab.engine.visibility;

/**
 * One colour 0xAARRGGBB per face, and one for its outline.
 *
 * <p>The arrays are not copied, since a picture reads them once for each face: whoever makes a
 * paint does not write into them afterwards.
 *
 * @param fill by face
 * @param outline by face; an empty array where no outline is drawn
 */
public record FacePaint(int[] fill, int[] outline) {
    public FacePaint {
        if (outline.length != 0 && outline.length != fill.length)
            throw new IllegalArgumentException(
                    "outline needs a colour for none or each of %d faces, got %d"
                            .formatted(fill.length, outline.length));
    }

    public boolean hasOutline() {
        return outline.length != 0;
    }
}
