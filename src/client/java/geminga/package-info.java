/**
 * Services of a robot team and the channels between them. A {@link geminga.Node} is one program's connection to its daemon; it makes
 * {@link geminga.Publisher}s from {@link geminga.Offer}s and {@link geminga.Subscriber}s from {@link geminga.Request}s.
 */
package geminga;
