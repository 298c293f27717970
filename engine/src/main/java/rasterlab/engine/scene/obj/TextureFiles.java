package rasterlab.engine.scene.obj;

import java.util.Optional;
import rasterlab.engine.texture.Texture;

/** Opens the textures that materials name. */
@FunctionalInterface
public interface TextureFiles {
    /**
     * @param map as the material has it; its names may be any text, so take none for a path
     *     unchecked
     * @return empty where there is no such picture, after which the colour stands for it
     */
    Optional<Texture> open(ObjMaterial.Map map);
}
