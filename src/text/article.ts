/** 'a cone', 'an ellipsoid': by the first letter, which is right for the names of shapes. */
export const withArticle = (noun: string): string =>
  `${/^[aeiou]/.test(noun) ? 'an' : 'a'} ${noun}`;
