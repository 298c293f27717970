package rasterlab.contract;

/** Which light a surface sends back beside ambient light and emission. */
public enum Reflection {
    /** A dull surface: the diffuse term n·l alone. */
    LAMBERT,
    /** Beside it (r·v)ˢ, r being the mirrored direction to the light, v that to the eye. */
    PHONG,
    /** Beside it (n·h)ˢ, h being half way between the directions to the light and to the eye. */
    BLINN_PHONG
}
