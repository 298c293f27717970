/**
 * Topic {@code color}: one colour in five models, there and back.
 *
 * <p>Shares from 0 to 1, hues in degrees; {@link rasterlab.contract.ColorModel} says what each
 * number is. {@link rasterlab.engine.color.Levels} is the one place where shares become the 256
 * levels of a picture. Start with {@link rasterlab.engine.color.Hexcone} and {@link
 * rasterlab.engine.color.GrayDiagonal}; {@link rasterlab.engine.color.ColorTopic} lists everything.
 */
package rasterlab.engine.color;
