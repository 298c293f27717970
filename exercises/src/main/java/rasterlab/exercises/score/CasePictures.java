package rasterlab.exercises.score;

/**
 * A wrong case as pictures.
 *
 * @param text rows of characters: {@code #} right, {@code +} extra, {@code -} missing, {@code .}
 *     empty
 * @param expectedPng the exact picture, PNG
 * @param actualPng what was drawn, PNG
 * @param differencePng missing, extra and right pixels told apart by shape and colour, PNG
 */
public record CasePictures(
        String text, byte[] expectedPng, byte[] actualPng, byte[] differencePng) {}
