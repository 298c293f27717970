package rasterlab.contract;

/** Which light a surface sends back beside ambient light and emission. */
public enum Reflection {
    /** A dull surface: the diffuse term n·l alone. */
    LAMBERT,
    /** Adds (r·v)ˢ, r being the mirrored direction to the light, v that to the eye. */
    PHONG,
    /** Adds (n·h)ˢ, h being half way between the directions to the light and to the eye. */
    BLINN_PHONG
}
