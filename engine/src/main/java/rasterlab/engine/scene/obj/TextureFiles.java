package rasterlab.engine.scene.obj;

import rasterlab.engine.texture.Texture;

/** Opens the textures that materials name. */
@FunctionalInterface
public interface TextureFiles {
    /**
     * @param name as the material's file has it; it may be any text, so take it for no path
     *     unchecked
     * @param place where it is named, for messages
     */
    Texture open(String name, String place);
}
