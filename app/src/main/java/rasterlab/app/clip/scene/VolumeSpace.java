package rasterlab.app.clip.scene;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** The space in which the view volume is shown: before, between and after its normalisations. */
public enum VolumeSpace {
    /** The volume as seen: a pyramid through the screen. */
    EYE,
    /** The volume after NORMALIZE: |x| ≤ z, |y| ≤ z, zmin ≤ z ≤ 1, where segments are clipped. */
    @JsonProperty("NORMALISED")
    NORMALIZED,
    /** The volume after CANONICAL and the division by H: a box. */
    CANONICAL;

    /** Lower-case name, the key of its texts. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    public static VolumeSpace coded(String code) {
        return Named.find("space", code, List.of(values()), VolumeSpace::code);
    }
}
